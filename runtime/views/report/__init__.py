"""Reports: what a run did, as one dictionary, and as report.json and report.md."""

from runtime.results.as_json import as_json
from runtime.views.report.run import SECTIONS, run_report
from runtime.views.report.write import as_markdown, write_report

__all__ = ["SECTIONS", "as_json", "as_markdown", "run_report", "write_report"]
