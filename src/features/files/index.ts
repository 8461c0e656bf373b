/* Program files, chosen or dropped. */

export const fetchChooseProgram = () => import("./ChooseProgram.tsx");
