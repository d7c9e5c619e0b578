// The theme: that of the system, or the one that was chosen here. In the head of every page, so that nothing flashes.
// No module, because modules wait for the page.
"use strict";
{
  const kept = "bnserve-theme";
  const chosen = () => localStorage.getItem(kept) || "auto";
  const apply = () => document.documentElement.setAttribute("data-theme", chosen());
  apply();
  document.addEventListener("DOMContentLoaded", () => {
    const button = document.getElementById("theme");
    if (!button) return;
    const label = () => {
      const names = { auto: "Theme: system", light: "Theme: light", dark: "Theme: dark" };
      button.textContent = { auto: "◐", light: "☀", dark: "☾" }[chosen()];
      button.setAttribute("aria-label", names[chosen()]);
      button.title = names[chosen()];
    };
    label();
    button.addEventListener("click", () => {
      const order = ["auto", "light", "dark"];
      localStorage.setItem(kept, order[(order.indexOf(chosen()) + 1) % order.length]);
      apply();
      label();
      window.dispatchEvent(new Event("theme"));
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => window.dispatchEvent(new Event("theme")));
  });
}
