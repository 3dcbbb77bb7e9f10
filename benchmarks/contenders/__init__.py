"""What the generated code is measured against."""
