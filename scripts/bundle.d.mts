/** scripts/NAME.ts with all it imports as the text of one module for plain Node. */
export function bundle(name: string, how?: { readonly minify?: boolean }): Promise<string>;
/** The page objects of the journeys as one module that needs Playwright alone, and its types. */
export function pageObjects(): Promise<{ readonly code: string; readonly types: string }>;
