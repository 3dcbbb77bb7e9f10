"""Reports: what a run did, as one dictionary, and as report.json and report.md."""

from runtime.report.run import SECTIONS, run_report
from runtime.report.write import as_json, as_markdown, write_report

__all__ = ["SECTIONS", "as_json", "as_markdown", "run_report", "write_report"]
