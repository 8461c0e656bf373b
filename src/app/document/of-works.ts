/** What steps of undo are steps of that change the list of works. */
export const OF_WORKS = {};
