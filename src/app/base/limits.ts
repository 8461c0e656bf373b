/**
 * Largest program that is opened from a file or unpacked from a link, bytes: twice the longest that is measured
 * (docs/performance.md).
 */
export const LARGEST_PROGRAM = 20_000_000;
/** Most that is read from one folder: files, and depth of nested folders. */
export const MOST_FILES = 500;
export const DEEPEST_FOLDER = 8;
/** Longest address that every browser opens, characters. */
export const LONGEST_LINK = 2_000_000;
/** Longest address that all programs pass on uncut, characters. */
export const SAFE_LINK = 8000;
