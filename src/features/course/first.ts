/* The part of this feature that the first screen needs. */

export { TaskLine } from "./task/TaskLine.tsx";
export { IncomingTaught } from "./teach/IncomingTaught.tsx";
