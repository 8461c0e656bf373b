import type { IncomingMessage, ServerResponse } from "node:http";

export const contentPolicy: string;
export const securityHeaders: Readonly<Record<string, string>>;
export const cacheRules: { readonly assets: string; readonly others: string };
export const types: Readonly<Record<string, string>>;
export function site(folder: string, under?: string): (request: IncomingMessage, response: ServerResponse) => Promise<void>;
export function wholePath(path: string): string;
