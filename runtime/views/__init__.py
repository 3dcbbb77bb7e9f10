"""What people look at: plots, films, report files."""
