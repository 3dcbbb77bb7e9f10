"""The moving mechanism as one page that needs no network: poses and modes in JSON, drawn by the browser."""

from runtime.views.viewer.page import View, show, view, write_view

__all__ = ["View", "show", "view", "write_view"]
