// SPDX-License-Identifier: MIT
// Pieces of a document.

export const element = (id) => document.getElementById(id);

export function optionOf(value, text) {
  return Object.assign(document.createElement("option"), { value, textContent: text });
}

/** Saves a text or a blob as a file of that name. */
export function download(name, content) {
  const address = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type: "text/plain" }));
  Object.assign(document.createElement("a"), { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
