/* The part of this feature that the first screen needs. */

export { DropProgram } from "./DropProgram.tsx";
