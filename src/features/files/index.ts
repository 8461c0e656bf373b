/* Program files that are chosen or dropped. */

export const fetchChooseProgram = () => import("./ChooseProgram.tsx");
