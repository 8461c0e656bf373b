/* What the first screen shows of this feature. */

export { CreateProgram } from "./CreateProgram.tsx";
export { StartPage } from "./StartPage.tsx";
