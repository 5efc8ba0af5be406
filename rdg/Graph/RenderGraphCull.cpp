// Decides which passes are left out, and writes down why.
#include "RenderGraphCull.h"

#include <algorithm>

namespace Drydock
{

namespace
{

bool IsRoot(const FRDGPassDescription& Pass)
{
	return Pass.bIsSentinel || !Pass.bHasParameters || Pass.bHasExternalOutputs ||
		   EnumHasAnyFlags(Pass.Flags, ERDGPassFlags::NeverCull);
}

std::vector<int32_t> FindRoots(const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies)
{
	std::vector<int32_t> Roots;
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		if (IsRoot(Pass))
		{
			Roots.push_back(Pass.Index);
		}
	}
	for (size_t Resource = 0; Resource < Graph.Resources.size(); ++Resource)
	{
		if (Graph.Resources[Resource].bExternal || Graph.Resources[Resource].bExtracted)
		{
			const std::vector<int32_t>& Writers = Dependencies.LastWriters[Resource];
			Roots.insert(Roots.end(), Writers.begin(), Writers.end());
		}
	}
	return Roots;
}

/** "output A is", "outputs A and B are", "outputs A, B and C are". */
std::string DescribeOutputs(const FRDGGraphDescription& Graph, const FRDGPassDescription& Pass)
{
	std::vector<std::string> Names;
	for (const FRDGUse& Use : Pass.Uses)
	{
		const std::string& Name = Graph.Resources[size_t(Use.Resource)].Name;
		if (Use.IsWrite() && std::find(Names.begin(), Names.end(), Name) == Names.end())
		{
			Names.push_back(Name);
		}
	}
	std::string Text = Names.size() > 1 ? "outputs " : "output ";
	for (size_t Index = 0; Index < Names.size(); ++Index)
	{
		const char* const Separator = Index == 0 ? "" : Index + 1 == Names.size() ? " and " : ", ";
		Text += Separator + Names[Index];
	}
	return Text;
}

bool HasOutputs(const FRDGPassDescription& Pass)
{
	return std::any_of(Pass.Uses.begin(), Pass.Uses.end(), [](const FRDGUse& Use) { return Use.IsWrite(); });
}

const char* IsOrAre(const std::string& Outputs)
{
	return Outputs.compare(0, 8, "outputs ") == 0 ? " are" : " is";
}

/** Where the first consumers of a culled pass lead: a consumer always comes after its producer. */
struct FChain
{
	int32_t Next = -1; // the first consumer
	int32_t End = -1;  // the pass that nobody reads
	int32_t Length = 0;
};

/** By pass. A culled pass's consumers are all culled, else it would have survived. */
std::vector<FChain> FindChains(const FRDGDependencies& Dependencies)
{
	std::vector<FChain> Chains(Dependencies.Producers.size());
	for (int32_t Pass = int32_t(Chains.size()) - 1; Pass >= 0; --Pass)
	{
		FChain& Chain = Chains[size_t(Pass)];
		Chain.End = Chain.Next < 0 ? Pass : Chains[size_t(Chain.Next)].End;
		Chain.Length = Chain.Next < 0 ? 0 : Chains[size_t(Chain.Next)].Length + 1;
		for (const int32_t Producer : Dependencies.Producers[size_t(Pass)])
		{
			Chains[size_t(Producer)].Next = Pass;
		}
	}
	return Chains;
}

/** "A -> B -> C"; of a long one the first and the last passes, so that the reasons of all passes stay short. */
std::string DescribeChain(const FRDGGraphDescription& Graph, const std::vector<FChain>& Chains, int32_t Pass)
{
	constexpr int32_t MostNamed = 16;
	const FChain& Whole = Chains[size_t(Pass)];
	const int32_t NumNamed = Whole.Length <= MostNamed ? Whole.Length : MostNamed - 1;
	std::string Text;
	for (int32_t Step = 0; Step < NumNamed; ++Step)
	{
		Pass = Chains[size_t(Pass)].Next;
		Text += (Text.empty() ? "" : " -> ") + Graph.Passes[size_t(Pass)].Name;
	}
	if (NumNamed < Whole.Length)
	{
		Text +=
			" -> " + std::to_string(Whole.Length - NumNamed - 1) + " more -> " + Graph.Passes[size_t(Whole.End)].Name;
	}
	return Text;
}

/** What the pass's outputs would have gone into. */
std::string ExplainCulled(
	const FRDGGraphDescription& Graph, const std::vector<FChain>& Chains, const FRDGPassDescription& Pass)
{
	if (!HasOutputs(Pass))
	{
		return "no output: the pass writes nothing";
	}
	const std::string Outputs = DescribeOutputs(Graph, Pass);
	const std::string Chain = DescribeChain(Graph, Chains, Pass.Index);
	if (Chain.empty())
	{
		return "no reader: " + Outputs + IsOrAre(Outputs) + " neither read by a surviving pass nor extracted";
	}
	const FRDGPassDescription& End = Graph.Passes[size_t(Chains[size_t(Pass.Index)].End)];
	const std::string Text = "no reader: " + Outputs + IsOrAre(Outputs) + " used only by culled passes (" + Chain + ")";
	if (!HasOutputs(End))
	{
		return Text + ", and " + End.Name + " writes nothing";
	}
	const std::string EndOutputs = DescribeOutputs(Graph, End);
	return Text + ", and " + EndOutputs + " of " + End.Name + IsOrAre(EndOutputs) +
		   " neither read by a surviving pass nor extracted";
}

} // namespace

FRDGCullResult CullPasses(const FRDGGraphDescription& Graph, const FRDGDependencies& Dependencies, bool bEnabled)
{
	FRDGCullResult Result;
	Result.bCulled.assign(Graph.Passes.size(), bEnabled);
	Result.Reasons.resize(Graph.Passes.size());
	if (!bEnabled)
	{
		return Result;
	}

	std::vector<int32_t> Stack = FindRoots(Graph, Dependencies);
	while (!Stack.empty())
	{
		const size_t Pass = size_t(Stack.back());
		Stack.pop_back();
		if (Result.bCulled[Pass])
		{
			Result.bCulled[Pass] = false;
			const std::vector<int32_t>& Producers = Dependencies.Producers[Pass];
			Stack.insert(Stack.end(), Producers.begin(), Producers.end());
		}
	}

	const std::vector<FChain> Chains = FindChains(Dependencies);
	for (const FRDGPassDescription& Pass : Graph.Passes)
	{
		if (Result.bCulled[size_t(Pass.Index)])
		{
			Result.Reasons[size_t(Pass.Index)] = ExplainCulled(Graph, Chains, Pass);
		}
	}
	return Result;
}

} // namespace Drydock
