import { mountPage } from "../mountPage";
import { FleetPage } from "./FleetPage";

await mountPage(<FleetPage />);
