// Keeps the page in the browser, so that it works without a network. A new version is loaded as a whole, or not at all.

declare const FILES: readonly string[];
declare const VERSION: string;

/** What is used of a service worker's scope. */
interface Scope {
  addEventListener(kind: "install" | "activate", hear: (event: { waitUntil(done: Promise<unknown>): void }) => void): void;
  addEventListener(kind: "fetch", hear: (event: { readonly request: Request; respondWith(answer: Promise<Response>): void }) => void): void;
  skipWaiting(): Promise<void>;
  readonly clients: { claim(): Promise<void> };
}
const scope = self as unknown as Scope;
const NAME = `unoclp-${VERSION}`;
/** What a teacher changes while the page is served: asked for anew where there is a network. */
const FRESH = /\/(?:exercises|machines)\.json$/;

scope.addEventListener("install", (event) => {
  const load = async (): Promise<void> => {
    const cache = await caches.open(NAME);
    await cache.addAll(FILES.map((file) => new Request(file, { cache: "reload" })));
    await scope.skipWaiting();
  };
  event.waitUntil(load());
});

scope.addEventListener("activate", (event) => {
  const tidy = async (): Promise<void> => {
    const names = (await caches.keys()).filter((name) => name.startsWith("unoclp-") && name !== NAME);
    await Promise.all(names.map((name) => caches.delete(name)));
    await scope.clients.claim();
  };
  event.waitUntil(tidy());
});

scope.addEventListener("fetch", (event) => {
  if (event.request.method !== "GET") return;
  const answer = async (): Promise<Response> => {
    const cache = await caches.open(NAME);
    if (FRESH.test(new URL(event.request.url).pathname)) {
      const fresh = await fetch(event.request).catch(() => null);
      if (fresh?.ok) return fresh;
    }
    return (await cache.match(event.request, { ignoreSearch: true })) ?? fetch(event.request);
  };
  event.respondWith(answer());
});
