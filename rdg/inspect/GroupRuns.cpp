// Sorts threads by the groups that they are in.
#include "GroupRuns.h"

#include <map>

namespace Drydock
{

uint32_t GetIndexInGroup(const FInspectedShader& Shader, const std::array<int32_t, 3>& Position)
{
	const uint32_t* const Size = Shader.GetModule().LocalSize;
	const auto Local = [&](size_t Axis)
	{
		return uint32_t(Position[Axis]) % Size[Axis];
	};
	return (Local(2) * Size[1] + Local(1)) * Size[0] + Local(0);
}

std::vector<FGroupOfThreads> SortByGroups(
	const FInspectedShader& Shader, const std::vector<std::array<int32_t, 3>>& Threads)
{
	const uint32_t* const Size = Shader.GetModule().LocalSize;
	std::map<std::array<int32_t, 3>, std::vector<size_t>> Groups; // by z, y, x
	for (size_t i = 0; i < Threads.size(); ++i)
	{
		const std::array<int32_t, 3>& At = Threads[i];
		Groups[{At[2] / int32_t(Size[2]), At[1] / int32_t(Size[1]), At[0] / int32_t(Size[0])}].push_back(i);
	}
	std::vector<FGroupOfThreads> Result;
	for (auto& [Id, List] : Groups)
	{
		Result.push_back({{Id[2], Id[1], Id[0]}, std::move(List)});
	}
	return Result;
}

} // namespace Drydock
