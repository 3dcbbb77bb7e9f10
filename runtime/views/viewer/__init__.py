"""The moving mechanism as one page that needs no network: poses and modes in JSON, drawn by the browser."""
