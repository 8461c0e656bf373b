import { act, cleanup, render, screen } from "@testing-library/react";
import { Suspense } from "react";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import {
  dismissMissing,
  fetchMissing,
  followMissing,
  isMissing,
  lazyPart,
  lazyWithin,
  retryImport,
  useMissing,
} from "./parts.ts";

const GONE = new TypeError("Failed to fetch dynamically imported module: http://host/assets/part-x.js");
const server = { answers: false };
beforeEach(() => {
  server.answers = false;
  vi.stubGlobal("fetch", () =>
    server.answers ? Promise.resolve({ ok: true }) : Promise.reject(new TypeError("no network")),
  );
});
afterEach(() => {
  cleanup();
  dismissMissing();
  vi.unstubAllGlobals();
});
const missing = () => useMissing.getState().missing;

test.each([
  "Failed to fetch dynamically imported module: http://host/a.js",
  "error loading dynamically imported module: http://host/a.js",
  "Importing a module script failed.",
  "Unable to preload CSS for http://host/a.css",
])("%s: a failed import", (message) => expect(isMissing(new TypeError(message))).toBe(true));

test("an error of our own is no failed import", async () => {
  expect(isMissing(new TypeError("x is undefined"))).toBe(false);
  await expect(retryImport(() => Promise.reject(new TypeError("x is undefined")))).rejects.toThrow("x is undefined");
  expect(missing()).toBe("no");
});

test("a component that cannot be loaded is announced, does not fail, and loads once the network is back", async () => {
  let asked = 0;
  const Part = lazyWithin(() => {
    asked += 1;
    return server.answers ? Promise.resolve({ default: () => <b>here</b> }) : Promise.reject(GONE);
  });
  render(
    <Suspense fallback={<i>coming</i>}>
      <Part />
    </Suspense>,
  );
  await vi.waitFor(() => expect(missing()).toBe("offline"));
  expect(screen.getByText("coming")).toBeTruthy();
  await act(async () => fetchMissing());
  await vi.waitFor(() => expect(missing()).toBe("offline"));
  expect(asked).toBe(2);
  server.answers = true;
  await act(async () => fetchMissing());
  await screen.findByText("here");
  expect(missing()).toBe("no");
  expect(asked).toBe(3);
});

test("a part with a boundary of its own leaves its place empty until it is here", async () => {
  const server = { has: false };
  const Part = lazyPart(async () => {
    if (!server.has) throw GONE;
    return { default: ({ of }: { readonly of: string }) => <b>{of}</b> };
  });
  const { container } = render(
    <Suspense fallback={<i>all of it</i>}>
      <Part of="here" />
    </Suspense>,
  );
  await vi.waitFor(() => expect(missing()).toBe("offline"));
  expect(container.textContent).toBe("");
  server.has = true;
  await act(async () => fetchMissing());
  await vi.waitFor(() => expect(container.textContent).toBe("here"));
});

test("a part that the server no longer has is announced as such", async () => {
  server.answers = true;
  const store = { has: false };
  const part = retryImport(() => (store.has ? Promise.resolve("here") : Promise.reject(GONE)));
  await vi.waitFor(() => expect(missing()).toBe("gone"));
  store.has = true;
  fetchMissing();
  expect(await part).toBe("here");
});

test("a failed import after a click is announced and not retried", async () => {
  followMissing();
  const refused = (reason: unknown) => {
    const event = new Event("unhandledrejection", { cancelable: true });
    Object.assign(event, { reason });
    dispatchEvent(event);
    return event.defaultPrevented;
  };
  expect(refused(new Error("a fault"))).toBe(false);
  expect(missing()).toBe("no");
  expect(refused(GONE)).toBe(true);
  expect(missing()).toBe("offline");
  dispatchEvent(new Event("online"));
  expect(missing()).toBe("no");
});

test("a part waits for its style sheet, which is loaded again", async () => {
  followMissing();
  const link = document.createElement("link");
  link.rel = "stylesheet";
  link.href = "http://host/assets/part.css";
  document.head.append(link);
  link.dispatchEvent(new Event("error"));
  const got = { part: "" };
  void retryImport(() => Promise.resolve("here")).then((part) => (got.part = part));
  const second = document.querySelector("link");
  expect(second).not.toBe(link);
  expect(second?.href).toBe(link.href);
  second?.dispatchEvent(new Event("error"));
  await vi.waitFor(() => expect(missing()).toBe("offline"));
  expect(got.part).toBe("");
  fetchMissing();
  await vi.waitFor(() => expect(document.querySelector("link")).not.toBe(second));
  document.querySelector("link")?.dispatchEvent(new Event("load"));
  await vi.waitFor(() => expect(got.part).toBe("here"));
  document.querySelector("link")?.remove();
});
