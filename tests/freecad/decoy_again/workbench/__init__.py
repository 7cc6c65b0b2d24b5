"""Another addon's workbench; harmless, but not ours."""

NOT_OURS = True
