"""Where a motion starts: rigid, quasi-static, given."""
