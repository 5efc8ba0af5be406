// Collects remarks that passes leave on their graph: not mistakes of the graph, but facts that its author should know
// (a clamp, a loss, a width that was not reached). They lie on the builder's blackboard; whoever runs the graph shows
// them.
#pragma once

#include "Diagnostics.h"
#include "RenderGraphBuilder.h"

#include <set>
#include <string>
#include <vector>

namespace Drydock
{

struct FRDGNotes
{
	std::vector<FDiagnostic> Diagnostics; // in the order of the passes, each text once
	std::set<std::string> Texts;          // of all of them
};

} // namespace Drydock

RDG_REGISTER_BLACKBOARD_STRUCT(Drydock::FRDGNotes)

namespace Drydock
{

inline void AddGraphNote(FRDGBuilder& GraphBuilder, const FDiagnostic& Diagnostic)
{
	FRDGNotes& Notes = GraphBuilder.Blackboard.GetOrCreate<FRDGNotes>();
	if (Notes.Texts.insert(Diagnostic.ToString()).second)
	{
		Notes.Diagnostics.push_back(Diagnostic);
	}
}

/** Also after Execute. */
inline std::vector<FDiagnostic> GetGraphNotes(const FRDGBuilder& GraphBuilder)
{
	const FRDGNotes* Notes = GraphBuilder.Blackboard.Get<FRDGNotes>();
	return Notes ? Notes->Diagnostics : std::vector<FDiagnostic>();
}

} // namespace Drydock
