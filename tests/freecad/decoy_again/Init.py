"""A second addon with our names, which imports its own `solver`: that must not become ours."""

import contextlib

# Not there where the other decoy's came first on the path.
with contextlib.suppress(ImportError):
    import solver  # noqa: F401
