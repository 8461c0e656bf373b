/* Program files that are chosen or dropped. */

export { DropProgram } from "./DropProgram.tsx";
export const fetchChooseProgram = () => import("./ChooseProgram.tsx");
