/* Whole programs: their text, the dialogs of their blocks, their operations. */

export const fetchProgramWorkplace = () => import("./ProgramWorkplace.tsx");
export const fetchInsertCycle = () => import("./insert-cycle.ts");
export const fetchNewProgram = () => import("./operations/NewProgram.tsx");
