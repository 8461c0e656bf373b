/* Ways to start a program. */

export const fetchBeginCycle = () => import("./begin.ts");
