/**
 * A number with a minus and what it belongs to, such as Z-35: it would break behind the minus. Chinese writes no spaces
 * round it.
 */
const NUMBER = /([\p{Script=Latin}\d⌀=+.,]*-\d[\d.,]*)/u;

/** The pieces of a text: every second one, from the second on, is a number with a minus, which no line end may part. */
export const numbersApart = (text: string): readonly string[] => text.split(NUMBER);
