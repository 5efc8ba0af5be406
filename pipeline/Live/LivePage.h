// The page of `drydock live`.
#pragma once

#include <string>

namespace Drydock
{

/** The whole of it, as report/ makes it. Throws FError (exit code 3) where drydock's own file is missing. */
std::string ReadLivePage();

} // namespace Drydock
