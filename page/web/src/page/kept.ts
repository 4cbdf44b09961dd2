// What the browser keeps from visit to visit. One that keeps nothing, or is full, still runs programs.

/** What was kept under a name; null where nothing was, or cannot be. */
export function kept(name: string): string | null {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

/** Keeps a text; says whether it is kept. */
export function keep(name: string, text: string): boolean {
  try {
    localStorage.setItem(name, text);
    return true;
  } catch {
    return false;
  }
}
