// Something on its way to a place of the sheet, under a mouse, a pen or a finger.

import type { Place } from "../../tools/answers";
import { h } from "../dom";

/** The sheet as something is carried over it. */
export interface Carried {
  /** The places light up, or no longer. */
  light(on: boolean): void;
  /** The place that is nearest to a point of the window, which is marked; null where none is near. */
  near(x: number, y: number): { readonly at: number; readonly place: Place } | null;
  put(what: string, at: number, place: Place): void;
}

interface Ends {
  click(event: PointerEvent): void;
  drop(at: number, place: Place): void;
}

/** So far a pointer moves before it carries, in px. */
const SLACK = 6;

/** Lets a pointer carry what an element of the page stands for; `face` is what is seen of it on the way, null where it stays. */
export function carry(handle: Element, face: (event: PointerEvent) => string | null, ends: Ends, over: Carried): void {
  handle.addEventListener("pointerdown", (begun) => {
    const down = begun as PointerEvent;
    if (down.button !== 0) return;
    const shown = face(down);
    let ghost: HTMLElement | null = null;
    const stop = new AbortController();
    const { signal } = stop;
    const end = (): void => {
      stop.abort();
      ghost?.remove();
      if (ghost) over.light(false);
    };
    const mine = (event: Event): event is PointerEvent => (event as PointerEvent).pointerId === down.pointerId;
    addEventListener("pointermove", (event) => {
      if (!mine(event) || shown === null) return;
      if (!ghost && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) > SLACK) {
        ghost = h("div", { class: "ghost", "aria-hidden": "true" }, shown);
        document.body.append(ghost);
        over.light(true);
      }
      if (!ghost) return;
      ghost.style.translate = `${event.clientX}px ${event.clientY}px`;
      over.near(event.clientX, event.clientY);
    }, { signal });
    addEventListener("pointerup", (event) => {
      if (!mine(event)) return;
      const carried = ghost !== null;
      const place = carried ? over.near(event.clientX, event.clientY) : null;
      end();
      if (!carried) ends.click(event);
      else if (place) ends.drop(place.at, place.place);
    }, { signal });
    addEventListener("pointercancel", (event) => {
      if (mine(event)) end();
    }, { signal });
    addEventListener("keydown", (event) => {
      if (event.key === "Escape") end();
    }, { signal });
  });
  // What a keyboard or a screen reader presses has no pointer.
  handle.addEventListener("click", (event) => {
    if ((event as MouseEvent).detail === 0) ends.click(event as PointerEvent);
  });
}
