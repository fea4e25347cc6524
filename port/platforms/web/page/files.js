// SPDX-License-Identifier: MIT
// Files in and out: a recording that is dropped or opened, a bout that is saved.

// The largest file that a page should take at once: half an hour of a bout.
const kMostBytes = 200e6;

/** What a file is, by its first bytes; its name says less. */
function kindOf(bytes) {
  const head = new TextDecoder("latin1").decode(bytes.subarray(0, 4096));
  return /^\s*(# EVEMU|[NIPBALSE]: )/m.test(head) && !head.includes("\0") ? "device" : "bout";
}

export async function readFile(file) {
  if (file.size > kMostBytes) throw new Error(`${file.name} is too large for this page (${Math.round(file.size / 1e6)} MB)`);
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length === 0) throw new Error(`${file.name} is empty`);
  const kind = kindOf(bytes);
  return kind === "device" ? { kind, name: file.name, text: new TextDecoder().decode(bytes) } : { kind, name: file.name, bytes };
}

export function acceptDrops(target, take) {
  target.addEventListener("dragover", (event) => event.preventDefault());
  target.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer.files.length > 0) take(event.dataTransfer.files[0]);
  });
}

export function save(bytes, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes], { type: "application/octet-stream" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
