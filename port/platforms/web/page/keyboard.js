// SPDX-License-Identifier: MIT
// Keys of the page. What has the focus and uses a key itself keeps it: a list its arrows and numbers, a button Enter. Letters are
// the fencer's wherever the focus is, and Escape takes it away.

const isLetter = (code) => /^Key[A-Z]$/.test(code);
const keeps = (element, code) => (element instanceof HTMLSelectElement || element instanceof HTMLInputElement) && !isLetter(code);
const usesEnter = (element) => element instanceof HTMLButtonElement || element instanceof HTMLAnchorElement || element instanceof HTMLSelectElement;

/** @param acts  by KeyboardEvent.code */
export function keyboard(keys, acts) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
    if (event.code === "Escape") {
      document.activeElement.blur();
    } else if (keys.isStick(event.code) && !keeps(event.target, event.code)) {
      keys.set(event.code, true);
      event.preventDefault();
    } else if (event.code in acts && !event.repeat && !keeps(event.target, event.code) && !(event.code === "Enter" && usesEnter(event.target))) {
      acts[event.code]();
      event.preventDefault();
    }
  });
  document.addEventListener("keyup", (event) => {
    if (keys.isStick(event.code)) keys.set(event.code, false);
  });
}
