"""Pages of the documentation whose every number is computed."""
