export function findBrowser(): string | null;
export function findLightBrowser(): string | null;
export function ensureBrowser(): string;
export const browserFlags: string[];
