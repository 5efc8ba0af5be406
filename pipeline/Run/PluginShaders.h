// The global shader classes that plugins registered, even if no known pass uses them: the shader of a lambda pass is
// not known before it runs.
#pragma once

#include "Overlay/OverlayFolder.h"
#include "RenderGraphCompiled.h"
#include "ShaderCompilation.h"

#include <string>
#include <vector>

namespace Drydock
{

/** Permutations of one class that are looked at: a class of more has some spread over all of its dimensions. */
constexpr int32 MaxPermutationsLookedAt = 256;

struct FPluginShaders
{
	std::vector<FShaderRef> Permutations; // those that ShouldCompilePermutation allows
	size_t NumClasses = 0;
	std::vector<std::string> Plugins; // of the classes, by file name
	bool bOverlaid = false;           // classes of drydock's own are among them
	std::vector<FDiagnostic> Notes;   // classes of which not all permutations are in the list

	/** "2 shader classes of its plugins, 13 permutations" */
	DRYDOCK_API std::string Describe() const;
};

/** Plugins: files of the loaded plugins whose classes are wanted. Overlays: classes that read one of their files are
 * wanted, too, of drydock's own the first permutations. The permutations that a class allows may depend on console
 * variables. */
DRYDOCK_API FPluginShaders FindPluginShaders(
	const std::vector<std::string>& Plugins, const std::vector<FOverlayFolder>& Overlays = {});

/** Puts the permutations through the front end. Throws FError with the messages of all that fail, each once. */
DRYDOCK_API void ReflectShaders(const FPluginShaders& Shaders);

/** A note for each pass of a plugin that names no shader, if its plugin has no shader classes to check instead. */
DRYDOCK_API std::vector<FDiagnostic> FindUnseenPasses(const FRDGCompiledGraph& Graph, const FPluginShaders& Shaders);

} // namespace Drydock
