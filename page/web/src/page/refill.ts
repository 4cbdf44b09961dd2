// Fields that are made anew: the one in which somebody writes keeps the focus, and what is written there.

/** The fields in which something was begun that nobody has taken yet. */
const begun = new WeakSet<EventTarget>();
addEventListener("input", ({ target }) => void (target && begun.add(target)), true);
addEventListener("change", ({ target }) => void (target && begun.delete(target)), true);

/** Replaces what stands in `root`. Where it `keeps`, a text that was begun in a field goes on in the new field of the same id,
 * and of the same `data-of`. */
export function refill(root: HTMLElement, children: readonly HTMLElement[], keeps = true): void {
  const { activeElement: was } = document;
  const isInside = was !== null && was.id !== "" && root.contains(was);
  root.replaceChildren(...children);
  const now = isInside ? root.querySelector<HTMLElement>(`#${CSS.escape(was.id)}`) : null;
  now?.focus();
  if (!keeps || !isWritten(was) || !isWritten(now) || !begun.has(was) || was.dataset["of"] !== now.dataset["of"]) return;
  now.value = was.value;
  begun.add(now);
  now.setSelectionRange(was.selectionStart, was.selectionEnd);
}

/** Whether one writes in it. */
export function isWritten(field: Element | null): field is HTMLInputElement | HTMLTextAreaElement {
  return field instanceof HTMLTextAreaElement || (field instanceof HTMLInputElement && field.type === "text");
}
