// Says in words why passes and resources of a compiled graph are left out, when somebody asks.
#include "RenderGraphCompiled.h"

#include "TextTools.h"

#include <algorithm>

namespace Drydock
{

namespace
{

/** Names that a text lists at most. */
constexpr int32_t MostNamed = 16;

/** "output A is", "outputs A and B are", "outputs A, B and C are". */
std::string DescribeOutputs(const FRDGCompiledGraph& Graph, const FRDGPassDescription& Pass)
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
	return (Names.size() > 1 ? "outputs " : "output ") + JoinWords(Names);
}

bool HasOutputs(const FRDGPassDescription& Pass)
{
	return std::any_of(Pass.Uses.begin(), Pass.Uses.end(), [](const FRDGUse& Use) { return Use.IsWrite(); });
}

const char* IsOrAre(const std::string& Outputs)
{
	return Outputs.starts_with("outputs ") ? " are" : " is";
}

/** "A -> B -> C"; of a long one the first and the last passes. */
std::string DescribeChain(const FRDGCompiledGraph& Graph, const FRDGCompiledPass& Pass)
{
	const FRDGCulledChain& Whole = Pass.Readers;
	const int32_t NumNamed = Whole.Length <= MostNamed ? Whole.Length : MostNamed - 1;
	std::string Text;
	int32_t At = Pass.Index;
	for (int32_t Step = 0; Step < NumNamed; ++Step)
	{
		At = Graph.Passes[size_t(At)].Readers.Next;
		Text += (Text.empty() ? "" : " -> ") + Graph.Passes[size_t(At)].Name;
	}
	if (NumNamed < Whole.Length)
	{
		Text +=
			" -> " + std::to_string(Whole.Length - NumNamed - 1) + " more -> " + Graph.Passes[size_t(Whole.End)].Name;
	}
	return Text;
}

} // namespace

std::string FRDGCompiledGraph::DescribeCulled(const FRDGCompiledPass& Pass) const
{
	if (!Pass.bCulled)
	{
		return "";
	}
	if (!HasOutputs(Pass))
	{
		return "no output: the pass writes nothing";
	}
	const std::string Outputs = DescribeOutputs(*this, Pass);
	const std::string Chain = DescribeChain(*this, Pass);
	if (Chain.empty())
	{
		return "no reader: " + Outputs + IsOrAre(Outputs) + " neither read by a surviving pass nor extracted";
	}
	const FRDGCompiledPass& End = Passes[size_t(Pass.Readers.End)];
	const std::string Text = "no reader: " + Outputs + IsOrAre(Outputs) + " used only by culled passes (" + Chain + ")";
	if (!HasOutputs(End))
	{
		return Text + ", and " + End.Name + " writes nothing";
	}
	const std::string EndOutputs = DescribeOutputs(*this, End);
	return Text + ", and " + EndOutputs + " of " + End.Name + IsOrAre(EndOutputs) +
		   " neither read by a surviving pass nor extracted";
}

std::string FRDGCompiledGraph::DescribeUnused(const FRDGCompiledResource& Resource) const
{
	if (Resource.FirstPass >= 0)
	{
		return "";
	}
	const std::vector<int32_t>& Users = Resource.CulledUsers;
	if (Users.empty())
	{
		return "no pass uses it";
	}
	const size_t NumNamed = Users.size() <= size_t(MostNamed) ? Users.size() : size_t(MostNamed) - 1;
	std::string Text = "all passes that use it are culled: ";
	for (size_t Index = 0; Index < NumNamed; ++Index)
	{
		Text += (Index == 0 ? "" : ", ") + Passes[size_t(Users[Index])].Name;
	}
	return NumNamed == Users.size() ? Text : Text + " and " + std::to_string(Users.size() - NumNamed) + " more";
}

} // namespace Drydock
