import type { ESLint } from "eslint";

/** The rules of this project. */
export declare const own: ESLint.Plugin;
