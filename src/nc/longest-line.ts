/**
 * Characters of one line of a program. A control's editor takes far fewer; a longer line stays in the text as it is,
 * is told and is not executed (docs/decisions/0058).
 */
export const LONGEST_LINE = 2000;
