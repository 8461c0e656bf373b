/* What the first screen shows of this feature. */

export { TaskLine } from "./task/TaskLine.tsx";
export { IncomingTaught } from "./teach/IncomingTaught.tsx";
