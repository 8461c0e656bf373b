/**
 * A negative number with its prefix, such as Z-35: browsers would break it after the minus. Chinese has no spaces
 * around it.
 */
const NUMBER = /([\p{Script=Latin}\d⌀=+.,]{0,30}-\d[\d.,]*)/u;

/** The text in pieces: every second one, from index 1, is a negative number, which must not break. */
export const splitNegativeNumbers = (text: string): readonly string[] => text.split(NUMBER);
