// Fields that are made anew: the one in which somebody writes keeps the focus, and what is written there.

/** Replaces what stands in `root`. Where it `keeps`, a text that was begun in a field goes on in the new field of the same id. */
export function refill(root: HTMLElement, children: readonly HTMLElement[], keeps = true): void {
  const { activeElement: was } = document;
  const isInside = was !== null && was.id !== "" && root.contains(was);
  root.replaceChildren(...children);
  const now = isInside ? root.querySelector<HTMLElement>(`#${CSS.escape(was.id)}`) : null;
  now?.focus();
  if (!keeps || !isWritten(was) || !isWritten(now) || was.value === was.defaultValue || was.value.trim() === now.value) return;
  now.value = was.value;
  if (was.selectionStart !== null) now.setSelectionRange(was.selectionStart, was.selectionEnd);
}

/** Whether one writes in it. */
export function isWritten(field: Element | null): field is HTMLInputElement | HTMLTextAreaElement {
  return field instanceof HTMLTextAreaElement || (field instanceof HTMLInputElement && field.type === "text");
}
