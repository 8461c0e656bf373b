/** scripts/NAME.ts with all it imports as the text of one module for plain Node. */
export function bundle(name: string, how?: { readonly minify?: boolean }): Promise<string>;
