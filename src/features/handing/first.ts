/* What the first screen shows of this feature. */

export { HandedLine, IncomingWork } from "./HandedParts.tsx";
