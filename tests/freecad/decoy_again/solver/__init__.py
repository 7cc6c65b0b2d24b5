"""Another addon's solver; harmless, but not ours."""

NOT_OURS = True
