"""Version of this library; the server of the same repository has the same."""

__version__ = "0.1.0"
