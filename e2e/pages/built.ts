import type * as Pages from "./index.ts";

/** The page objects as the build exports them to other test projects. */
export const built = (await import(new URL("../../dist/playwright.mjs", import.meta.url).href)) as typeof Pages;
