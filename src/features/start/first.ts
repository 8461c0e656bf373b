/* The part of this feature that the first screen needs. */

export { openExample } from "./open-example.ts";
export { CreateProgram } from "./CreateProgram.tsx";
export { StartPage } from "./StartPage.tsx";
