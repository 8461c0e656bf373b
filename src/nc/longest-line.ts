/**
 * Characters of one line of a program. A control's editor takes far fewer; a longer line stays in the text as it is,
 * gets an error and is not executed (docs/decisions/0060).
 */
export const LONGEST_LINE = 2000;
