import { mountPage } from "./mountPage";
import { StartingPage } from "./pages/StartingPage";

await mountPage(<StartingPage />);
