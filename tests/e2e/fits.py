"""Whether a page fits its screen: what a person would have to scroll sideways for, or not find."""

from playwright.sync_api import Page, ViewportSize

SIZES: tuple[ViewportSize, ...] = (
    {"width": 1440, "height": 900},
    {"width": 1280, "height": 800},
    {"width": 1024, "height": 768},
    {"width": 820, "height": 1180},
    {"width": 640, "height": 400},
)
"""Two laptops, a tablet both ways, and the second laptop at 200 %."""

MISFITS = """() => {
  const found = [];
  const root = document.documentElement;
  const named = (element) => {
    const words = element.getAttribute("aria-label") ?? element.textContent ?? "";
    return `${element.tagName.toLowerCase()} “${words.trim().slice(0, 40)}”`;
  };
  const scrolls = (way) => way === "auto" || way === "scroll";
  const shown = [...document.querySelectorAll("body *")].filter((element) => {
    const { width, height } = element.getBoundingClientRect();
    return element instanceof HTMLElement && width > 1 && height > 1 && element.checkVisibility();
  });
  const columns = [];
  for (const element of [root, ...shown]) {
    const { overflowX, overflowY, textOverflow } = getComputedStyle(element);
    const cuts = overflowX === "hidden" && textOverflow !== "ellipsis";
    const isWide = element.clientWidth > 0 && element.scrollWidth > element.clientWidth + 1;
    if (isWide && (element === root || scrolls(overflowX)))
      found.push(`${named(element)} scrolls sideways`);
    if (isWide && cuts && element !== document.body)
      for (const inner of element.querySelectorAll("*")) {
        const isText = [...inner.childNodes].some((one) => one.nodeType === 3 && one.data.trim());
        const { right, width } = inner.getBoundingClientRect();
        if (isText && width > 1 && right > element.getBoundingClientRect().right + 1)
          found.push(`${named(inner)} is cut off`);
      }
    const isHigh = element.scrollHeight > element.clientHeight + 1;
    if (isHigh && scrolls(overflowY)) columns.push(element);
  }
  for (const column of columns)
    for (const other of columns) {
      const [a, b] = [column.getBoundingClientRect(), other.getBoundingClientRect()];
      const shared = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      if (column !== other && shared > Math.min(a.width, b.width) / 2)
        found.push(`${named(column)} and ${named(other)} have two scroll bars in one column`);
    }
  const isAsked = document.querySelector("[aria-modal=true]");
  const buttons = isAsked ? [] : shown.filter((one) => one.matches("[data-kind=primary]"));
  for (const button of buttons) {
    const { left, right, top, bottom } = button.getBoundingClientRect();
    for (const x of [left + 8, (left + right) / 2, right - 8])
      for (const y of [top + 6, (top + bottom) / 2, bottom - 6]) {
        const seen = document.elementFromPoint(x, y);
        if (!seen) found.push(`${named(button)} is outside`);
        else if (!button.contains(seen)) found.push(`${named(button)} is under ${named(seen)}`);
      }
  }
  const headings = [...document.querySelectorAll("h1")].filter((one) => one.checkVisibility());
  if (headings.length !== 1) found.push(`headings: ${headings.map(named).join(", ") || "none"}`);
  return [...new Set(found)];
}"""


def misfits(page: Page) -> list[str]:
    """Where the page as it is scrolls sideways or twice in one column, cuts off text, hides a main
    button, or has not one heading."""
    found: list[str] = page.evaluate(MISFITS)
    return found
