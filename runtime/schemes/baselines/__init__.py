"""Established methods as steps of the same kind: what the schemes are judged against."""
