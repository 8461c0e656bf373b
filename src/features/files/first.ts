/* What the first screen shows of this feature. */

export { DropProgram } from "./DropProgram.tsx";
