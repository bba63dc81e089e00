// Elements without HTML in strings: what robots are called is text and nothing else.
type Child = Node | string;

export function el<Name extends keyof HTMLElementTagNameMap>(
  name: Name,
  attributes: Record<string, string> = {},
  ...children: Child[]
): HTMLElementTagNameMap[Name] {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

export const counted = (count: number, what: string) => `${count} ${what}${count === 1 ? "" : "s"}`;

// A button that is on or off, with the key that does the same.
export function toggle(label: string, key: string, on: boolean, change: (on: boolean) => void) {
  const button = el("button", { type: "button", "aria-pressed": String(on), title: `key ${key === " " ? "space" : key}` }, label);
  button.addEventListener("click", () => {
    const now = button.getAttribute("aria-pressed") !== "true";
    button.setAttribute("aria-pressed", String(now));
    change(now);
  });
  return button;
}
