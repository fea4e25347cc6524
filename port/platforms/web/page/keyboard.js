// SPDX-License-Identifier: MIT
// Keys of the page. What has the focus and uses a key itself (a list, a button) keeps it.

const usesArrows = (element) => element instanceof HTMLSelectElement || element instanceof HTMLInputElement;
const usesEnter = (element) => element instanceof HTMLButtonElement || element instanceof HTMLAnchorElement || element instanceof HTMLSelectElement;

/** @param acts  by KeyboardEvent.code */
export function keyboard(keys, acts) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || document.querySelector("dialog[open]")) return;
    if (keys.isStick(event.code) && !usesArrows(event.target)) {
      keys.set(event.code, true);
      event.preventDefault();
    } else if (event.code in acts && !event.repeat && !usesArrows(event.target) && !(event.code === "Enter" && usesEnter(event.target))) {
      acts[event.code]();
      event.preventDefault();
    }
  });
  document.addEventListener("keyup", (event) => {
    if (keys.isStick(event.code)) keys.set(event.code, false);
  });
}
