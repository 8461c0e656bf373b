/* Which cycle makes a shape. */

export const fetchWhichCycle = () => import("./WhichCycle.tsx");
