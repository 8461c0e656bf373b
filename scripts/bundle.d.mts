/** scripts/NAME.ts with all its imports as the text of one module for plain Node. */
export function bundle(name: string, how?: { readonly minify?: boolean }): Promise<string>;
/** The page objects of the e2e tests as one module that needs only Playwright, and its types. */
export function pageObjects(): Promise<{ readonly code: string; readonly types: string }>;
