// Opened from a file, the theme's search cannot start its worker: the page "search" takes its place.
if (location.protocol === "file:") {
  document.querySelectorAll(".md-search, .md-search__button, [data-md-component=search]").forEach(function (part) {
    part.style.display = "none";
  });
}
