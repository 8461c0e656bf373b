/* The start page, and a new program. */

export { CreateProgram } from "./CreateProgram.tsx";
export { StartPage } from "./StartPage.tsx";
