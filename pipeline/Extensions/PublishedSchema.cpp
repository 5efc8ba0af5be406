// Writes types and parameters out of the registries into the schema.
#include "Extensions/PublishedSchema.h"

#include "Config/ConfigSchema.h"
#include "Config/ConfigSchemaNames.h"
#include "ExtensionFactory.h"
#include "Extensions/FactoryTypes.h"
#include "PassFactory.h"
#include "Picture/ImageMetrics.h"
#include "Text/JsonWriter.h"

#include <cmath>

namespace Drydock
{

namespace
{

void WriteDefault(FJsonWriter& Writer, const FParameterValue& Value)
{
	const bool bText = std::holds_alternative<std::string>(Value);
	Writer.Key("default").Raw(bText ? FJsonWriter::Quote(std::get<std::string>(Value)) : ToText(Value));
}

void WriteParameter(FJsonWriter& Writer, const FParameterSpec& Spec)
{
	Writer.Key(Spec.Name).BeginObject(true);
	Writer.Member("description", Spec.Doc);
	switch (Spec.Kind)
	{
	case EParameterKind::Number:
	case EParameterKind::Integer:
		WriteType(Writer, Spec.Kind == EParameterKind::Number ? "number" : "integer");
		if (std::isfinite(Spec.Min))
		{
			Writer.Member("minimum", Spec.Min);
		}
		if (std::isfinite(Spec.Max))
		{
			Writer.Member("maximum", Spec.Max);
		}
		break;
	case EParameterKind::Bool:
		WriteType(Writer, "boolean");
		break;
	case EParameterKind::Text:
		WriteType(Writer, "string");
		if (!Spec.Choices.empty())
		{
			WriteEnum(Writer, Spec.Choices);
		}
		break;
	case EParameterKind::Color:
		WriteReference(Writer, "color");
		break;
	}
	WriteDefault(Writer, Spec.Default);
	Writer.EndObject();
}

void WriteParameters(FJsonWriter& Writer, const std::vector<FParameterSpec>& Parameters)
{
	for (const FParameterSpec& Spec : Parameters)
	{
		WriteParameter(Writer, Spec);
	}
}

/** {"if": its type is Type, "then": {"properties": what Write writes}} */
template<typename TWrite>
void WriteRule(FJsonWriter& Writer, const std::string& Type, const TWrite& Write)
{
	Writer.BeginObject();
	Writer.Key("if").BeginObject(true);
	Writer.Key("properties").BeginObject(true);
	Writer.Key("type").Object({{"const", Type}});
	Writer.EndObject();
	Writer.EndObject();
	Writer.Key("then").BeginObject();
	Writer.Key("properties").BeginObject();
	Write();
	Writer.EndObject();
	Writer.EndObject();
	Writer.EndObject();
}

void WriteExtensionRule(FJsonWriter& Writer, const FExtensionFactory& Factory)
{
	WriteRule(Writer, Factory.Type,
		[&]
		{
			if (!Factory.Passes.empty())
			{
				Writer.Key("pass").Object({{"enum", Factory.Passes}, {"default", Factory.Passes[0]}});
			}
			WriteParameters(Writer, Factory.Parameters);
		});
}

void WritePassRule(FJsonWriter& Writer, const FPassFactory& Factory)
{
	WriteRule(Writer, Factory.Type,
		[&]
		{
			Writer.Key("inputs").BeginObject();
			Writer.Key("properties").BeginObject();
			for (const FPassInputSpec& Input : Factory.Inputs)
			{
				Writer.Key(Input.Name).Object({{"description", Input.Doc}, TypeOf("string")});
			}
			Writer.EndObject();
			Writer.Member("additionalProperties", false);
			Writer.EndObject();
			Writer.Key("parameters").BeginObject();
			Writer.Key("properties").BeginObject();
			WriteParameters(Writer, Factory.Parameters);
			Writer.EndObject();
			Writer.Member("additionalProperties", false);
			Writer.EndObject();
		});
}

void WriteRules(FJsonWriter& Writer, const std::string& Object)
{
	if (Object == "extension")
	{
		for (const FExtensionFactory* Factory : GetExtensionFactories())
		{
			WriteExtensionRule(Writer, *Factory);
		}
		return;
	}
	for (const FPassFactory* Factory : GetPassFactories())
	{
		WritePassRule(Writer, *Factory);
	}
}

} // namespace

std::string MakePublishedSchema()
{
	FSchemaNames Names;
	Names.Extensions = GetFactoryTypes(GetExtensionFactories());
	Names.Passes = GetFactoryTypes(GetPassFactories());
	Names.Hooks = GetPassNames();
	Names.Hooks.insert(Names.Hooks.begin(), PrePostProcessPassName);
	Names.Metrics = GetMetricNames();
	Names.WriteTypeRules = WriteRules;
	return MakeConfigSchema(Names);
}

} // namespace Drydock
