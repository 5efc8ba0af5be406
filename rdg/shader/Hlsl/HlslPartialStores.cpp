// Walks over the statements of a program.
#include "HlslPartialStores.h"

#include <set>

namespace Drydock::Hlsl
{

namespace
{

/** A place that is some components of a texel, but not all. */
bool IsPartOfTexel(const FValue& Place)
{
	const FValue* Part = &Place;
	bool bPart = false;
	while (Part->Kind == EValue::Swizzle || (Part->Kind == EValue::Index && Part->Operands[0]->Type->IsNumeric()))
	{
		const std::set<uint8_t> Parts(Part->Parts.begin(), Part->Parts.end());
		bPart = bPart || (Part->Kind == EValue::Index ? Part->Operands[0]->Type->Columns > 1
													  : Parts.size() < Part->Operands[0]->Type->Columns);
		Part = Part->Operands[0];
	}
	const FType* const Object = Part->Kind == EValue::Element ? Part->Operands[0]->Type : nullptr;
	return bPart && Object && Object->IsObject() && (IsTexture(Object->Object) || Object->Object == EObject::RWBuffer);
}

class FPartialStores
{
public:
	std::vector<FPlace> Places;

	void Visit(const std::vector<FCode*>& Body)
	{
		for (const FCode* Code : Body)
		{
			Visit(Code);
		}
	}

	void Visit(const FCode* Code)
	{
		if (!Code)
		{
			return;
		}
		bFound = false;
		Visit(Code->Value);
		Visit(Code->Next);
		if (bFound)
		{
			Places.push_back(Code->Place);
		}
		Visit(Code->Body);
		for (const FCase& Case : Code->Cases)
		{
			Visit(Case.Body);
		}
	}

private:
	void Visit(const FValue* Value)
	{
		if (!Value)
		{
			return;
		}
		const bool bWrites =
			Value->Kind == EValue::Assign || Value->Kind == EValue::Modify || Value->Kind == EValue::Step;
		bFound = bFound || (bWrites && IsPartOfTexel(*Value->Operands[0]));
		for (size_t i = 0; i < Value->Operands.size(); ++i)
		{
			const FFunction* const Called = Value->Kind == EValue::Call ? Value->Function : nullptr;
			const bool bOut = Called && i < Called->Parameters.size() && Called->Parameters[i]->Modifiers & ModifierOut;
			bFound = bFound || (bOut && IsPartOfTexel(*Value->Operands[i]));
			Visit(Value->Operands[i]);
		}
	}

	bool bFound = false;
};

} // namespace

std::vector<FPlace> ListPartialStores(const FProgram& Program)
{
	FPartialStores Stores;
	for (const FFunction* Function : Program.Functions)
	{
		Stores.Visit(Function->Body);
	}
	return Stores.Places;
}

} // namespace Drydock::Hlsl
